The image of a board is started if it is of the graph. CMake and the emulator are stand-ins here.
  $ mkdir stand_ins && cat >stand_ins/cmake <<'END'
  > #!/bin/sh
  > if [ "$1" = --build ]; then printf "$IMAGE" >"$2/multi_rate.elf"; fi
  > END
  $ printf '#!/bin/sh\necho "started $*"\n' >stand_ins/qemu-system-arm && chmod +x stand_ins/*
  $ on_board=("$root/tests/golden/multi_rate/graph.yaml" --target mps2-an386 --quiet -o on_board)
  $ started() { PATH=$PWD/stand_ins:$PATH IMAGE=$1 eagerx-gen run "${on_board[@]}" | sed -E 's/(-M mps2-an386) .*/\1/'; }
  $ eagerx-gen generate "${on_board[@]}"
  $ hash=$(grep -rhoP 'kGraphHash = 0x\K[0-9a-f]{16}' on_board | head -n 1)
  $ for at in 14 12 10 8 6 4 2 0; do note+=$(printf '\\%03o' "0x${hash:at:2}"); done
  $ started "eagerx graph $note"
  started -M mps2-an386
  $ started 'eagerx graph \1\0\0\0\0\0\0\0' 2>&1 | sed "s/0x$hash/<hash>/"
  error[E0519]: `on_board/build/multi_rate.elf` was built from another graph: its hash is 0x0000000000000001, not <hash>
  help: delete the folder on_board/build, and try again
  
  1 error
  [1]
  $ started "of your own main function"
  started -M mps2-an386
