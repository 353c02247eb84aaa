package org.hificamsim.profiling.detector;

import java.util.List;

/** The score of the best box that lies on the object: one column. */
final class BoxSource implements ConfidenceSource {
  /**
   * How much a box and the object's patch must share. Less than the usual half: the window of the
   * people detector has a wide margin.
   */
  private static final double MIN_OVERLAP = 0.3;

  private final String name;
  private final BoxDetector detector;

  BoxSource(String name, BoxDetector detector) {
    this.name = name;
    this.detector = detector;
  }

  @Override
  public List<String> columns() {
    return List.of(name);
  }

  @Override
  public Look look(Photograph photo) {
    return new Boxes(detector.detect(photo));
  }

  @Override
  public void close() {
    detector.close();
  }

  private record Boxes(List<Box> boxes) implements Look {
    @Override
    public double[] confidences(Subject subject) {
      return best(boxes.stream().filter(b -> b.overlap(subject.patch()) >= MIN_OVERLAP).toList());
    }

    @Override
    public double[] falseConfidences(Subject subject) {
      return best(boxes);
    }

    private static double[] best(List<Box> boxes) {
      return new double[] {boxes.stream().mapToDouble(Box::score).max().orElse(0)};
    }

    @Override
    public void close() {}
  }
}
