package badlog.spark.sql

import badlog.season.lake.LakeException
import badlog.season.lake.LakeInventory
import badlog.season.lake.LakeLayout
import badlog.spark.storage.RemoteFolder
import org.apache.spark.sql.Dataset
import org.apache.spark.sql.Row
import org.apache.spark.sql.SparkSession
import org.apache.spark.util.SerializableConfiguration

/**
 * Queries of a lake in Spark's own SQL, with the tables and names of `docs/season.md`.
 *
 * @param address the address of the lake's folder, on any file system that Spark supports.
 * @throws LakeException if it is not a lake, or has another version.
 */
public class LakeQuery(private val spark: SparkSession, private val address: String) {
    private val views: SparkViews

    init {
        val lake = RemoteFolder(address, SerializableConfiguration(spark.sparkContext().hadoopConfiguration()), LakeLayout.DRAFT)
        if (!lake.has(LakeLayout.MARK)) throw LakeException("$address is not a lake; make one by badlog-spark lake.")
        LakeInventory.of(address, lake.text(LakeLayout.MARK), emptyList())
        views = SparkViews(spark, address, lake)
    }

    /**
     * Returns the answer to [sql], evaluated lazily.
     *
     * @throws org.apache.spark.sql.AnalysisException if the query is invalid, or names an unknown table or column.
     */
    public fun ask(sql: String): Dataset<Row> {
        views.makeFor(sql)
        return spark.sql(sql)
    }
}
