package org.hificamsim.placement.output;

import java.util.Map;

/**
 * The details of a project that the document of a plan shows at its top.
 *
 * @param entries the entries by name, such as the client and the date, in the order in which they
 *     are shown
 * @param currency the currency of all prices, such as EUR
 */
public record TitleBlock(Map<String, String> entries, String currency) {}
