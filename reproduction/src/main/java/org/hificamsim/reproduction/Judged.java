package org.hificamsim.reproduction;

import org.hificamsim.runs.Estimate;

/**
 * The verdict on a cell of Table 8.1 or on a statement of the text: a row of {@code verdicts.csv}.
 *
 * @param kind {@code cell} or {@code statement}
 * @param source section, table or figure of the thesis
 * @param text the claim
 * @param published the proportion of a cell; NaN for a statement
 * @param value the proportion of a cell that we find, or the weakest margin of a statement
 * @param checks the number of comparisons that decide
 * @param held the number of comparisons that hold
 * @param reason for the verdict, in one line
 * @param role whether our defaults were chosen for it
 */
public record Judged(
    String kind,
    String id,
    String source,
    String text,
    double published,
    Estimate value,
    int checks,
    int held,
    Verdict verdict,
    String reason,
    FitRole role) {}
