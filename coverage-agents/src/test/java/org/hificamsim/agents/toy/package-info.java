/** Toy networks that replace the engine in tests of policies. */
package org.hificamsim.agents.toy;
