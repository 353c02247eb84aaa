package org.hificamsim.profiling.check;

/** A point or a direction in the world or before a camera. */
record Vector(double x, double y, double z) {
  double dot(Vector other) {
    return x * other.x + y * other.y + z * other.z;
  }

  Vector cross(Vector other) {
    return new Vector(
        y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
  }

  double length() {
    return Math.sqrt(dot(this));
  }

  Vector times(double factor) {
    return new Vector(factor * x, factor * y, factor * z);
  }

  Vector plus(Vector other) {
    return new Vector(x + other.x, y + other.y, z + other.z);
  }
}
