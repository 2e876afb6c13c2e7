package badlog.spark

import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import org.apache.spark.SparkConf
import org.apache.spark.api.java.JavaSparkContext
import java.nio.file.Path

/** The folder of the Spark that `:spark:installSpark` installs; null if it is not installed. */
internal val SPARK_HOME: Path? = System.getProperty("badlog.spark.home")?.let(Path::of)

/** Enables a test if Spark is installed. */
internal val SPARK_IS_HERE: EnabledOrReasonIf = {
    if (SPARK_HOME != null) Enabled.enabled else Enabled.disabled("Apache Spark is not here; ./gradlew :spark:installSpark installs it.")
}

/** Spark in this process, on two threads. */
internal object LocalSpark {
    val context: JavaSparkContext by lazy {
        System.setProperty("log4j2.level", "ERROR")
        JavaSparkContext(
            SparkConf().setMaster("local[2]").setAppName("badlog-test")
                .set("spark.ui.enabled", "false")
                .set("spark.driver.host", "127.0.0.1")
                .set("spark.driver.bindAddress", "127.0.0.1")
                .set("spark.sql.shuffle.partitions", "2")
                // A limit below the size of a single log's samples, which must not reach the driver.
                .set("spark.driver.maxResultSize", "200k"),
        )
    }
}
