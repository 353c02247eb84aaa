/** The simulator's core: scenario, world, detection and policy interfaces, engine, metrics. */
@StableApi(since = "0.1")
package org.hificamsim.core;
