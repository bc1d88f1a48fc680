// The start-up of a firmware alone. The table has what the other programs need in addition.

int main() { return 0; }
