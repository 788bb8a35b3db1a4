"yes"
