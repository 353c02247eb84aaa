package org.hificamsim.hifi.model;

import java.util.function.Function;
import org.hificamsim.hifi.feature.FeatureAbstraction;
import org.hificamsim.hifi.json.JsonObject;

/**
 * How one type of feature abstraction is spelt in JSON.
 *
 * @param type the text of its property {@code type}
 * @param of the class, whose properties Jackson writes
 * @param reader makes one from these properties; those that it does not ask for are refused
 */
record FeatureFormat(
    String type,
    Class<? extends FeatureAbstraction> of,
    Function<JsonObject, FeatureAbstraction> reader) {}
