#version 3.7;
polynomial { 99, xyz(1, 0, 0): 1 }
polynomial { 2, xyz(1, 2, 0): 1 }
polynomial { 2, xyz(1, 1, 0) 1 }
polynomial { 2, xyz(1, 1): 1 }
ovus { -1, 2 }
