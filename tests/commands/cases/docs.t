The reference: of the build folder here, opened where there are a display and a browser.
  $ eagerx-gen docs
  file://<build>/site/index.html
  $ eagerx-gen docs butterworthfilter
  file://<build>/site/entities/ButterworthFilter.html
  $ eagerx-gen docs E0307 --address
  file://<build>/site/codes/E0307.html
  $ eagerx-gen docs budget
  file://<build>/site/keys.html#budget
  $ eagerx-gen docs linearize
  file://<build>/site/commands/linearize.html
  $ eagerx-gen docs ButerworthFilter
  error: the reference has no page for `ButerworthFilter`
  help: did you mean `ButterworthFilter`?
  [2]
  $ eagerx-gen docs pid
  error: the reference has no page for `pid`
  help: did you mean `PidController` or `design pid`?
  [2]
  $ eagerx-gen docs lqr
  error: the reference has no page for `lqr`
  help: did you mean `StateFeedback`?
  [2]
  $ printf '#!/bin/sh\necho "shows $1"\n' >browser && chmod +x browser
  $ DISPLAY=:0 BROWSER=$PWD/browser eagerx-gen docs budget
  file://<build>/site/keys.html#budget
  shows file://<build>/site/keys.html#budget
  $ DISPLAY=:0 BROWSER=$PWD/browser eagerx-gen docs budget --address
  file://<build>/site/keys.html#budget
  $ cp "$build/eagerx-gen" alone
  $ ./alone docs
  error: this eagerx-gen is installed without its reference
  help: `cmake --build BUILD --target site` makes it; it needs the Debian packages cmark-gfm and python3-yaml
  [3]
