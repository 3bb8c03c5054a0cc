# Read by the scripts beside: what both runs of a test must agree on.
# Share of the rounds with random input.
export ASPECT_TEST_PERCENT=10

# summary LOG: what Catch2 says at the end of a success; other programs say nothing.
summary() {
  grep -aoE 'All tests passed \([0-9]+ assertions in [0-9]+ test cases?\)' "$1" || echo 'exit code 0'
}
