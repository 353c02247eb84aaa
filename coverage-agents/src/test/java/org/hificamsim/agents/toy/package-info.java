/** Toy networks that stand in for the engine in the tests of policies. */
package org.hificamsim.agents.toy;
