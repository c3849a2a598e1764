Names of objects, nodes, actions and observations, and why others stay.
  $ cp "$root/tests/commands/spelled.yaml" robot.yaml
  $ sed -i "s|\.\./identify|$root/tests/identify|" robot.yaml
  $ eagerx-gen rename robot.yaml actions.force push
  robot.yaml: Rename `force` to `push`, 2 places
  $ eagerx-gen rename robot.yaml slow smoothed
  robot.yaml: Rename `slow` to `smoothed`, 2 places
  $ eagerx-gen rename robot.yaml observations.a acceleration --dry-run
  --- robot.yaml
  +++ robot.yaml
  @@ -17 +17 @@
  -observations: [v, a, smoothed]
  +observations: [v, acceleration, smoothed]
  @@ -21 +21 @@
  -  - {from: robot.a, to: observations.a}
  +  - {from: robot.a, to: observations.acceleration}
  $ eagerx-gen rename robot.yaml smooth filter
  robot.yaml: Rename `smooth` to `filter`, 3 places
  $ eagerx-gen check robot.yaml
  robot.yaml: 11 nodes, 2 rates, 15 buffers with room for 16 messages; no problems; 1 variant of the right form
  $ eagerx-gen rename robot.yaml robot.u v
  error: `robot.yaml` has no object, node, action or observation `robot.u`
  help: what is inside of `robot` has its name in the manifest of its type; `eagerx-gen rename robot.yaml robot NEW` renames `robot`
  [1]
  $ eagerx-gen rename robot.yaml heavy big
  error: `robot.yaml` has no object, node, action or observation `heavy`
  help: it is the name of one of `variants:`: change it where the graph has it
  [1]
  $ eagerx-gen rename robot.yaml filter robot
  error: there is `robot` already
  help: choose another name
  [1]
  $ eagerx-gen rename robot.yaml filter filter
  error: `filter` has this name
  [1]
  $ eagerx-gen rename robot.yaml filter 9a
  error: `9a` cannot be the name of an object or a node
  help: a name has letters, digits and `_`, begins with a letter, and is not `actions`, `observations`, `engine` or `environment`
  [1]
  $ eagerx-gen rename robot.yaml filter actions
  error: `actions` cannot be the name of an object or a node
  help: a name has letters, digits and `_`, begins with a letter, and is not `actions`, `observations`, `engine` or `environment`
  [1]
  $ eagerx-gen rename robot.yaml actions.push "a b"
  error: `a b` is not a name
  help: a name has letters, digits and `_`, and begins with no digit
  [1]
  $ eagerx-gen rename robot.yaml observations.v a
  error: there is `a` already
  help: choose another name
  [1]
