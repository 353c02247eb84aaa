/** Many simulations that are stepped by one call, with the data of learners in shared memory. */
package org.hificamsim.worlds;
