package badlog.spark

import badlog.rules.RulesException
import badlog.season.lake.LakeException
import badlog.spark.program.Jobs
import badlog.spark.program.UsageException
import org.apache.spark.sql.AnalysisException
import org.apache.spark.sql.SparkSession
import kotlin.system.exitProcess

private const val USAGE = """Usage: spark-submit badlog-spark.jar JOB …

  lake LOGS… --out LAKE [--rules FILE] [--max-size MB]     makes or refreshes a lake of the logs below the folders
  rules LOGS… --out FOLDER [--rules FILE] [--max-size MB]  runs rules over logs, or the logs of a lake: tables without samples
  sql LAKE QUERY [--out FOLDER] [--format parquet|csv|json]  answers SQL about a lake

Addresses may be of any file system that Spark knows. docs/spark.md has examples."""

/** Runs a job on the Spark chosen by `spark-submit`. */
internal fun main(args: Array<String>) {
    val words = args.drop(1)
    val job: (Jobs) -> Unit = when (args.firstOrNull()) {
        "lake" -> { jobs -> jobs.lake(words) }

        "rules" -> { jobs -> jobs.rules(words) }

        "sql" -> { jobs -> jobs.sql(words) }

        else -> {
            System.err.println(USAGE)
            exitProcess(WRONG_USAGE)
        }
    }
    val failure = SparkSession.builder().appName("badlog ${args.first()}").getOrCreate().use { spark ->
        failureOf { job(Jobs(spark, ::println)) }
    }
    if (failure == null) return
    System.err.println(failure)
    exitProcess(FAILED)
}

/** Runs [work]. Returns the reason why it failed, as a sentence; null if it succeeded. */
private fun failureOf(work: () -> Unit): String? = try {
    work()
    null
} catch (e: UsageException) {
    "${e.message}\n\n$USAGE"
} catch (e: LakeException) {
    e.message
} catch (e: RulesException) {
    e.message
} catch (e: AnalysisException) {
    e.message
}

private const val WRONG_USAGE = 2
private const val FAILED = 1
