/** Writes the tables of a run as Parquet files. */
package org.hificamsim.parquet;
