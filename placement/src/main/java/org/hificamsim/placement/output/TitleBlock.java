package org.hificamsim.placement.output;

import java.util.Map;

/**
 * What a plan's document says about itself.
 *
 * @param entries such as the client and the date, in the order in which they are shown
 * @param currency of all prices, such as EUR
 */
public record TitleBlock(Map<String, String> entries, String currency) {}
