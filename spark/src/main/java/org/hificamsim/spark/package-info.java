/** The runs of a comparison on Apache Spark: the only package that knows Spark. */
package org.hificamsim.spark;
