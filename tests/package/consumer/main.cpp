#include <sbgc/messages.hpp>
#include <sbgc/parser.hpp>

int main() { return 0; }
