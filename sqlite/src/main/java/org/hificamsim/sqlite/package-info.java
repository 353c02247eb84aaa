/** SQLite files of other simulators, read by their tables. */
package org.hificamsim.sqlite;
