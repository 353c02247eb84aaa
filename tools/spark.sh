# Sourced by ./hificamsim for --engine spark: finds Spark, builds the application jar, sets the variables at the end.
# shellcheck shell=sh

# Prints the folder of a Spark distribution: SPARK_HOME, or else that of the spark-submit on PATH, which pip may have installed.
spark_home() {
    submit=$(command -v spark-submit) && submit=$(dirname "$(readlink -f "$submit")")
    for spark in "${SPARK_HOME:-}" "${submit:+$submit/..}" "${submit:-/none}"/../lib/python3*/site-packages/pyspark; do
        for core in "${spark:-/none}"/jars/spark-core_*.jar; do
            [ -f "$core" ] && echo "$spark" && return
        done
        [ -z "${SPARK_HOME:-}" ] || return 1 # it is set but wrong, so nothing else is tried
    done
    return 1
}

spark=$(spark_home) || {
    echo "error: SPARK_HOME is '${SPARK_HOME:-}', expected the folder of Apache Spark 3.5 that has jars/, for --engine spark" >&2
    exit 2
}
application=${root:?}/spark/build/libs/hificamsim-spark.jar
build_if_stale "$application" :spark:application
# shellcheck disable=SC2034 # for the launcher
{
    spark_libraries="$spark/jars/*:$application"
    spark_options=$root/spark/java.options
    spark_log=$root/spark/log4j2.properties
}
