#include 12
