package org.hificamsim.bridge;

/**
 * A row of the log that the doubles write: what a camera saw of an object.
 *
 * @param returned the confidence that {@code update_visiblity} returned
 * @param kept the confidence in the camera's visible set; 0 if the object is not in it
 * @param heading the heading of the camera, in radians
 * @param angle the opening angle of the camera, in radians
 */
record Look(
    int step,
    String camera,
    String object,
    double range,
    double x,
    double y,
    double returned,
    double kept,
    double heading,
    double angle) {
  static Look parse(String row) {
    String[] cells = row.split(",", -1);
    return new Look(
        Integer.parseInt(cells[0]),
        cells[1],
        cells[2],
        Double.parseDouble(cells[3]),
        Double.parseDouble(cells[4]),
        Double.parseDouble(cells[5]),
        Double.parseDouble(cells[6]),
        cells[7].isEmpty() ? 0 : Double.parseDouble(cells[7]),
        Double.parseDouble(cells[8]),
        Double.parseDouble(cells[9]));
  }
}
