package org.hificamsim.runs.benchmark;

/** What was found of an entry's scores on fresh seeds, the worst first. */
public enum VerificationOutcome {
  /** The policy scores less, or other than the entry says in testing. */
  NOT_HELD("not held"),
  /** The scores hold, on a system that did not keep the policy from reading files. */
  UNCONFINED("unconfined"),
  /** The scores hold. */
  HELD("fresh seeds");

  private final String label;

  VerificationOutcome(String label) {
    this.label = label;
  }

  /** The word of tables. */
  String label() {
    return label;
  }

  /** The worse of two. */
  public static VerificationOutcome worse(VerificationOutcome one, VerificationOutcome other) {
    return one.compareTo(other) <= 0 ? one : other;
  }
}
