import random


def random_direction():
    return random.randint(0, 3)
