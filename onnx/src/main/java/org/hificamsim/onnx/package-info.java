/** Trained policies: networks in ONNX files that choose views from what cameras observe. */
package org.hificamsim.onnx;
