/** The simulator's core: scenario, world, detection and policy interfaces, engine, metrics. */
package org.hificamsim.core;
