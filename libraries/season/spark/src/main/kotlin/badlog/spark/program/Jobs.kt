package badlog.spark.program

import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.rules.RulesFile
import badlog.season.lake.LakeException
import badlog.spark.lake.SparkLake
import badlog.spark.lake.SparkLakeResult
import badlog.spark.sql.LakeQuery
import org.apache.hadoop.fs.Path
import org.apache.spark.api.java.JavaSparkContext
import org.apache.spark.sql.SaveMode
import org.apache.spark.sql.SparkSession
import java.io.IOException

/** The jobs of `badlog-spark`, which pass each line for the user to [say]. */
internal class Jobs(private val spark: SparkSession, private val say: (String) -> Unit) {
    private val context = JavaSparkContext(spark.sparkContext())

    /** `lake LOGS… --out LAKE`: makes or refreshes a lake. */
    fun lake(words: List<String>) {
        val arguments = Arguments.of(words, setOf(Arguments.OUT, Arguments.RULES, Arguments.MAX_SIZE))
        val lake = arguments.required(Arguments.OUT)
        report(lake, refresh(SparkLake(context, lake), arguments))
    }

    /** `rules LOGS… --out FOLDER`: runs the rules, and shows their findings. */
    fun rules(words: List<String>) {
        val arguments = Arguments.of(words, setOf(Arguments.OUT, Arguments.RULES, Arguments.MAX_SIZE))
        val out = arguments.required(Arguments.OUT)
        report(out, refresh(SparkLake(context, out, hasSamples = false), arguments))
        LakeQuery(spark, out).ask(COUNTS).show(MAX_PRINTED_ROWS, false)
    }

    /** `sql LAKE QUERY`: answers a question about a lake. */
    fun sql(words: List<String>) {
        val arguments = Arguments.of(words, setOf(Arguments.OUT, Arguments.FORMAT))
        if (arguments.named.size != 2) throw UsageException("Name a lake and a query: sql LAKE 'SELECT …'.")
        val (lake, query) = arguments.named
        val answer = LakeQuery(spark, lake).ask(query)
        val out = arguments.option(Arguments.OUT)
        if (out == null) {
            answer.show(MAX_PRINTED_ROWS, false)
        } else {
            val format = arguments.option(Arguments.FORMAT) ?: "parquet"
            if (format !in FORMATS) throw UsageException("${Arguments.FORMAT} $format: there are ${FORMATS.joinToString()}.")
            answer.write().format(format).mode(SaveMode.ErrorIfExists).option("header", true).save(out)
            say("The answer is in $out.")
        }
    }

    private fun refresh(lake: SparkLake, arguments: Arguments): SparkLakeResult {
        if (arguments.named.isEmpty()) throw UsageException("Name a folder of logs.")
        return lake.refresh(arguments.named, rulesOf(arguments.option(Arguments.RULES)), arguments.maxBytes())
    }

    private fun rulesOf(address: String?): RuleSet {
        if (address == null) return RuleSet.BUILT_IN
        val path = Path(address)
        val text = try {
            path.getFileSystem(context.hadoopConfiguration()).open(path).use { it.readAllBytes().decodeToString() }
        } catch (e: IOException) {
            throw LakeException("The rules $address cannot be read (${e.message}).", e)
        }
        return RulesFile.parse(text).rules
    }

    private fun report(lake: String, result: SparkLakeResult) {
        for (log in result.refused.sortedBy { it.path }) say("${log.path}: ${log.message}")
        val parts = listOfNotNull(
            "${result.written} written" + if (result.salvaged > 0) " (${result.salvaged} with data missing)" else "",
            if (result.unchanged > 0) "${result.unchanged} unchanged" else null,
            if (result.removed > 0) "${result.removed} removed" else null,
            if (result.refused.isNotEmpty()) "${result.refused.size} not in the lake" else null,
        )
        say("$lake: logs ${parts.joinToString()}")
    }

    private companion object {
        /** The maximum number of rows printed. */
        const val MAX_PRINTED_ROWS = 100
        val FORMATS = listOf("parquet", "csv", "json")
        const val COUNTS =
            "SELECT rule, severity, count(DISTINCT log) AS logs, count(*) AS findings FROM findings GROUP BY rule, severity " +
                "ORDER BY logs DESC, rule"
    }
}
