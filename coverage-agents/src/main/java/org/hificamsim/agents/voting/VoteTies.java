package org.hificamsim.agents.voting;

/** Which of the views with most votes wins; thesis 7.4.5 does not say. */
public enum VoteTies {
  /** The camera's own action where it is among them, else the widest. */
  OWN,
  WIDEST,
  NARROWEST
}
