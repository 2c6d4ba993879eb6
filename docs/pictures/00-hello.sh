draw
