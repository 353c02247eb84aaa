/**
 * Declarations of the elements and attributes of scenario files: name, type, unit, range, default
 * and meaning. Readers, the writer, the schema and the tables of the docs follow from them.
 */
@StableApi(since = "0.2")
package org.hificamsim.core.scenario.declaration;

import org.hificamsim.core.StableApi;
