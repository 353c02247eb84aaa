/** Messages between cameras, as a queue. */
package org.hificamsim.core.network.message;
