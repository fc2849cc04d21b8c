// In text that is read '#endif' is an error of its own.
#if (0)
  sphere { 0, 1 }
#endif
box { 0, 1 }
