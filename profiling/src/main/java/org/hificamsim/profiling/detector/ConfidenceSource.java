package org.hificamsim.profiling.detector;

import java.util.List;

/**
 * A detector at work, which makes one or more columns of confidences. An instance serves one
 * thread.
 */
public interface ConfidenceSource extends AutoCloseable {
  /** The names of its columns. */
  List<String> columns();

  /** Looks at a photo once; the caller closes the look. */
  Look look(Photograph photo);

  @Override
  void close();

  /** A photo that has been looked at. */
  interface Look extends AutoCloseable {
    /** One confidence for each column, in [0, 1]. */
    double[] confidences(Subject subject);

    /**
     * The same in a photo that does not have the object: what is taken for it. The subject's patch
     * says how large it would be.
     */
    default double[] falseConfidences(Subject subject) {
      return confidences(subject);
    }

    @Override
    void close();
  }
}
