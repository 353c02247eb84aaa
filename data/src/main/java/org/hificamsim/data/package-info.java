/** CSV and JSON files, read with the line and column of every fault, and written. */
package org.hificamsim.data;
