int windowOfTheStandIn() { return 0; }
