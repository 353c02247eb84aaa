/** Tables of a run as Parquet files, written and read. */
package org.hificamsim.parquet;
