#define A B B
#define B C C
#define C D D
#define D A
A