/** Computes the runs of a comparison on Apache Spark. */
package org.hificamsim.spark;
