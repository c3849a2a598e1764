A library with former names: the graph's `fix` says which files have them, and one command changes them all.
  $ for name in one two; do
  >   mkdir -p entities/$name
  >   cp "$root"/models/nodes/moving_average_filter/*.hpp entities/$name
  >   sed "s/^id: .*/id: Own_$name/; s/^vectorized:/packs:/" "$root/models/nodes/moving_average_filter/manifest.yaml" > entities/$name/manifest.yaml
  > done
  $ cp "$root/examples/pendulum_swing_up/graph.yaml" .
  $ eagerx-gen fix graph.yaml --path entities 2>&1 | grep 'eagerx-gen fix'
  help: `eagerx-gen fix entities/one/manifest.yaml entities/two/manifest.yaml` changes those files
  [1]
  $ eagerx-gen fix entities/*/manifest.yaml
  entities/one/manifest.yaml:14: Change to `vectorized`
  entities/two/manifest.yaml:14: Change to `vectorized`
  $ grep vectorized entities/*/manifest.yaml
  entities/one/manifest.yaml:vectorized: true
  entities/two/manifest.yaml:vectorized: true
A file that cannot be read keeps no other from being changed.
  $ sed -i 's/^vectorized:/packs:/' entities/two/manifest.yaml
  $ eagerx-gen fix missing.yaml entities/two/manifest.yaml
  error[E0101]: cannot read `missing.yaml`: no such file or directory
   --> missing.yaml
  help: available: `graph.yaml`
  
  1 error
  entities/two/manifest.yaml:14: Change to `vectorized`
  [3]
