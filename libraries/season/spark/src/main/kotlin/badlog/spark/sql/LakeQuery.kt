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
 * SQL over a lake, by Spark: the tables that `docs/season.md` names, by the same names, in Spark's own SQL.
 *
 * @param address of the lake's folder, on any file system that Spark knows.
 * @throws LakeException when it is not a lake, or one of another version.
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
     * Returns the answer to [sql], which is calculated when it is used.
     *
     * @throws org.apache.spark.sql.AnalysisException when it is wrong, or names what is not there.
     */
    public fun ask(sql: String): Dataset<Row> {
        views.makeFor(sql)
        return spark.sql(sql)
    }
}
