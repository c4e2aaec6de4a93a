class Chair:
    def __init__(self): self.legs = 4
c = Chair()
print(c.legs)
c.lges += 1
