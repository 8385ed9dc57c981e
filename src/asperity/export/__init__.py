"""A joint as other programs read it: curves as tables, and models with hysteresis and drift; no physics."""
