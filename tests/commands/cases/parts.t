A part of another machine: nothing is built before somebody has said how it is reached.
  $ { cat "$root/tests/golden/multi_rate/graph.yaml" && echo 'placement: {agent: {host: gpu_pc}}'; } >elsewhere.yaml
  $ eagerx-gen run elsewhere.yaml -o elsewhere
  error[E0518]: part `gpu_pc` runs on gpu_pc, and this machine cannot start it there
    --> elsewhere.yaml:62:13
     |
  62 | placement: {agent: {host: gpu_pc}}
     |             ^^^^^
  help: copy elsewhere/gpu_pc/build/multi_rate there and type `./multi_rate --listen :7001`; here `ssh -N -L 7001:localhost:7001 gpu_pc`; then add `--link gpu_pc=localhost:7001`. Without ssh it takes a key: `eagerx-gen key new gpu_pc.key`, then this command with `--key gpu_pc.key`
  
  1 error
  [1]
  $ eagerx-gen run elsewhere.yaml -o elsewhere --key gpu_pc=keys/gpu.key
  error[E0518]: there is no key `keys/gpu.key` for the line to part `gpu_pc`
    --> elsewhere.yaml:62:13
     |
  62 | placement: {agent: {host: gpu_pc}}
     |             ^^^^^
  help: `eagerx-gen key new keys/gpu.key` writes one
  
  1 error
  [1]
  $ mkdir keys && touch keys/gpu.key keys/a.key own.key
  $ eagerx-gen run elsewhere.yaml -o elsewhere --key gpu_pc=keys/gup.key
  error[E0518]: there is no key `keys/gup.key` for the line to part `gpu_pc`
    --> elsewhere.yaml:62:13
     |
  62 | placement: {agent: {host: gpu_pc}}
     |             ^^^^^
  help: did you mean `keys/gpu.key`?
  
  1 error
  [1]
  $ eagerx-gen run elsewhere.yaml -o elsewhere --key gpu_pc=keys/gpu.key
  error[E0518]: part `gpu_pc` runs on gpu_pc, and this machine cannot start it there
    --> elsewhere.yaml:62:13
     |
  62 | placement: {agent: {host: gpu_pc}}
     |             ^^^^^
  help: copy elsewhere/gpu_pc/build/multi_rate and keys/gpu.key there and type `./multi_rate --listen 0.0.0.0:7001 --key gpu.key`; then add `--link gpu_pc=gpu_pc:7001`
  
  1 error
  [1]
  $ sed 's/gpu_pc}}/gpu_pc, key: own.key}}/' elsewhere.yaml >elsewhere_key.yaml
  $ eagerx-gen run elsewhere_key.yaml -o elsewhere
  error[E0518]: part `gpu_pc` runs on gpu_pc, and this machine cannot start it there
    --> elsewhere_key.yaml:62:13
     |
  62 | placement: {agent: {host: gpu_pc, key: own.key}}
     |             ^^^^^
  help: copy elsewhere/gpu_pc/build/multi_rate and own.key there and type `./multi_rate --listen 0.0.0.0:7001 --key own.key`; then add `--link gpu_pc=gpu_pc:7001`
  
  1 error
  [1]
  $ eagerx-gen run elsewhere_key.yaml -o elsewhere --key keys/gpu.key
  error[E0518]: part `gpu_pc` runs on gpu_pc, and this machine cannot start it there
    --> elsewhere_key.yaml:62:13
     |
  62 | placement: {agent: {host: gpu_pc, key: own.key}}
     |             ^^^^^
  help: copy elsewhere/gpu_pc/build/multi_rate and keys/gpu.key there and type `./multi_rate --listen 0.0.0.0:7001 --key gpu.key`; then add `--link gpu_pc=gpu_pc:7001`
  
  1 error
  [1]
  $ [ ! -e elsewhere/host/build ]
Parts in other languages take keys, too.
  $ sed "s|^library.*|library: [$root/tests/languages/entities]|; s|^placement.*|placement: {half: {host: cam, target: python}}|" \
  >   "$root/tests/languages/page.yaml" >page.yaml
  $ eagerx-gen run page.yaml -o elsewhere_python --key keys/a.key
  error[E0518]: part `cam` runs on cam, and this machine cannot start it there
    --> page.yaml:17:13
     |
  17 | placement: {half: {host: cam, target: python}}
     |             ^^^^
  help: copy elsewhere_python/cam and keys/a.key there and type `python3 cam --listen 0.0.0.0:7001 --key a.key`; then add `--link cam=cam:7001`
  
  1 error
  [1]
  $ eagerx-gen run page.yaml -o elsewhere_python
  error[E0518]: part `cam` runs on cam, and this machine cannot start it there
    --> page.yaml:17:13
     |
  17 | placement: {half: {host: cam, target: python}}
     |             ^^^^
  help: copy elsewhere_python/cam there and type `python3 cam --listen :7001`; here `ssh -N -L 7001:localhost:7001 cam`; then add `--link cam=localhost:7001`. Without ssh it takes a key: `eagerx-gen key new cam.key`, then this command with `--key cam.key`
  
  1 error
  [1]
