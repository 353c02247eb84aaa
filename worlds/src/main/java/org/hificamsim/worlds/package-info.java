/**
 * Many simulations side by side, stepped by one call, with what learners need in shared buffers.
 */
package org.hificamsim.worlds;
