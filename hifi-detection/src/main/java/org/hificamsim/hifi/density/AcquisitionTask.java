package org.hificamsim.hifi.density;

/** Johnson's criteria as the NVESD model has them: cycles on target for an even chance. */
enum AcquisitionTask {
  DETECT(1.0),
  ORIENT(1.4),
  RECOGNISE(4.0),
  IDENTIFY(6.4);

  private final double cycles;

  AcquisitionTask(double cycles) {
    this.cycles = cycles;
  }

  /** N50. */
  double cycles() {
    return cycles;
  }
}
