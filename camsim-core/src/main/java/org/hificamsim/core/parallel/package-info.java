/** Work on the items of a list, shared among threads. */
package org.hificamsim.core.parallel;
