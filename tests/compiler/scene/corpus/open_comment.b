/* never closed
#endif