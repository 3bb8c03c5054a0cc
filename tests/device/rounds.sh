# Read by the scripts beside: what both runs of a test must agree on.
# Share of the rounds with random input.
export ASPECT_TEST_PERCENT=10

# summary TEST LOG: what Catch2 says at the end of a success; other programs say nothing. How often
# output_test asks depends on how its threads take turns.
summary() {
  local said
  said=$(grep -aoE 'All tests passed \([0-9]+ assertions in [0-9]+ test cases?\)' "$2") || said='exit code 0'
  [ "$1" != output_test ] || said=${said/[0-9]* assertions in/}
  echo "$said"
}
