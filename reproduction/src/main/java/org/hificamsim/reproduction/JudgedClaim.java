package org.hificamsim.reproduction;

import org.hificamsim.runs.Estimate;

/**
 * The verdict on a cell of Table 8.1 or on a statement of the text: a row of {@code verdicts.csv}.
 *
 * @param kind {@code cell} or {@code statement}
 * @param source section, table or figure of the publication
 * @param text the claim
 * @param published the proportion of a cell; NaN for a statement
 * @param value our proportion for a cell, or the weakest margin of a statement
 * @param checks number of comparisons that decide
 * @param held the number of comparisons that hold
 * @param reason reason for the verdict, in one line
 * @param role whether our defaults were chosen for it
 */
public record JudgedClaim(
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
