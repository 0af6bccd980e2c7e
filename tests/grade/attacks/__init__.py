"""attacks - a class of nothing but hostile submissions, with honest ones among them. __main__.py grades it."""
