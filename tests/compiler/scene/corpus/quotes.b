#define NAME "a//b" "
/* " */ surface { texture { map NAME map "\
" } } "
