#declare A = "never ends;
