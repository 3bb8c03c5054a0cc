# What bash would offer: bash_words.sh SCRIPT WORD..., of which the last is being completed. One a line.
source "$1"
shift
COMP_WORDS=("$@")
COMP_CWORD=$(($# - 1))
read -r _ _ function _ < <(complete -p "$1")
"$function"
printf '%s\n' "${COMPREPLY[@]}"
