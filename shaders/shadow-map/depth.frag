// Only the depth is kept, and that is written without us.
void main() {}
