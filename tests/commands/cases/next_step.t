The commands that are printed, up to configuring.
  $ graph=$root/tests/golden/multi_rate/graph.yaml
  $ next_step() { # NAME ARGUMENT...
  >   local name=$1 command
  >   shift
  >   command=$(eagerx-gen "$graph" "$@" -o "$name" | grep "^  cmake -S" | head -n 1)
  >   echo "$command"
  >   bash -c "${command%% && cmake --build*} -G Ninja -Deagerx_gen_DIR='$build'" >log 2>&1 || cat log
  > }
  $ next_step linux
    cmake -S linux -B linux/build && cmake --build linux/build && linux/build/multi_rate --help
  $ next_step "a board" --target mps2-an386
    cmake -S 'a board' -B 'a board/build' --toolchain <root>/toolchains/arm-none-eabi-cortex-m4f.cmake && cmake --build 'a board/build' && <root>/targets/run mps2-an386 'a board/build/multi_rate.elf'
  $ next_step several --target linux-sim --target mps2-an386
    cmake -S several -B several/build-linux-sim -D EAGERX_TARGET=linux-sim && cmake --build several/build-linux-sim && several/build-linux-sim/multi_rate --help
  $ eagerx-gen new board my-board -q
  $ sed -i 's/FILL_IN, FILL_IN/0x0, 4M/; s/^cpu:.*/cpu: mine/; s/^clock_hz:.*/clock_hz: 1000000/
  >   s/^toolchain:.*/toolchain: arm-none-eabi-cortex-m4f.cmake/' targets/my-board/manifest.yaml
  $ sed -i '/^#error/d' targets/my-board/board.cpp
  $ eagerx-gen new board my-board
  error[E0902]: there is already something at `targets/my-board`
  help: choose another name, or another folder with --output
  
  1 error
  [3]
  $ next_step mine --path targets --target my-board
    cmake -S mine -B mine/build --toolchain <root>/toolchains/arm-none-eabi-cortex-m4f.cmake -D EAGERX_TARGETS_PATH='<folder>/targets' && cmake --build mine/build
A machine without the cross compiler gets the names of the packages.
  $ mkdir no_compiler && ln -s "$(command -v cmake)" "$(command -v ninja)" no_compiler/
  $ for toolchain in "$root"/toolchains/*.cmake; do
  >   grep -q need-compiler "$toolchain" || continue
  >   echo "${toolchain##*/}"
  >   PATH=$PWD/no_compiler cmake -S mine -B "without_${toolchain##*/}" -G Ninja --toolchain "$toolchain" 2>&1 | tr -s ' \n' '  ' |
  >     grep -o 'there is no .* install it with `apt install "*[a-z][^`]*`'
  > done
  aarch64-linux-gnu.cmake
  there is no aarch64-linux-gnu-g++: install it with `apt install g++-aarch64-linux-gnu`
  arm-linux-gnueabihf.cmake
  there is no arm-linux-gnueabihf-g++: install it with `apt install g++-arm-linux-gnueabihf`
  arm-none-eabi.cmake
  there is no arm-none-eabi-g++: install it with `apt install gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-dev libstdc++-arm-none-eabi-newlib`
  emscripten.cmake
  there is no em++: install it with `apt install emscripten`
  riscv64-unknown-elf.cmake
  there is no riscv64-unknown-elf-g++: install it with `apt install gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf libstdc++-arm-none-eabi-dev`
  [1]
With this machine's compiler, and without the folder of the board.
  $ cmake -S mine -B wrong -G Ninja -Deagerx_gen_DIR="$build" -DEAGERX_TARGETS_PATH=targets 2>&1 | tr -s ' \n' '  ' |
  >   grep -o "is this machine's compiler"
  is this machine's compiler
  [1]
  $ cmake -S mine -B without_folder -G Ninja -Deagerx_gen_DIR="$build" 2>&1 | tr -s ' \n' '  ' | grep -o 'there is no target `my-board`' | head -n 1
  there is no target `my-board`
  [1]
