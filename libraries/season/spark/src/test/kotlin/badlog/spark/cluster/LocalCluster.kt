package badlog.spark.cluster

import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.div
import kotlin.io.path.readText

/**
 * A standalone Spark cluster on 127.0.0.1: processes of a master and two workers, each with one core. Their output is in [folder].
 *
 * @param home the folder of Spark.
 */
internal class LocalCluster(private val home: Path, private val folder: Path) : AutoCloseable {
    private val master = start("master", "org.apache.spark.deploy.master.Master", "--host", HOST, "--port", "0", "--webui-port", "0")
    private val address = awaitOutput("master") { ADDRESS.find(it)?.value }
    private val workers = (1..2).map { number ->
        start(
            "worker$number", "org.apache.spark.deploy.worker.Worker", "--host", HOST, "--cores", "1", "--memory", "1g", "--webui-port", "0",
            "--work-dir", "${folder / "work$number"}", address,
        )
    }

    init {
        for (number in 1..2) awaitOutput("worker$number") { text -> text.takeIf { "Successfully registered" in it } }
    }

    /** Submits the job [words] of [jar]. Its output is in the files `job` and `job.out` of the folder. */
    fun submit(jar: String, vararg words: String): Process {
        val options = listOf(
            "spark.executor.memory=700m",
            "spark.executor.cores=1",
            "spark.ui.enabled=false",
            "spark.driver.host=$HOST",
            "spark.driver.bindAddress=$HOST",
            "spark.driver.maxResultSize=1m",
            "spark.speculation=true",
        ).flatMap { listOf("--conf", it) }
        return process(
            "job",
            listOf("${home / "bin/spark-submit"}", "--master", address, "--driver-memory", "600m") + options + jar + words,
        ).redirectOutput((folder / "job.out").toFile()).start()
    }

    /** Kills a worker and its executor, as a power cut would. */
    fun killWorker() {
        val worker = workers.first()
        val executors = worker.descendants().toList()
        worker.destroyForcibly()
        executors.forEach(ProcessHandle::destroyForcibly)
    }

    /** Returns the output of the process [name]. */
    fun log(name: String): String = (folder / name).readText()

    private fun start(name: String, vararg command: String): Process = process(name, listOf("${home / "bin/spark-class"}") + command).redirectOutput(ProcessBuilder.Redirect.DISCARD).start()

    private fun process(name: String, command: List<String>) = ProcessBuilder(command).redirectError((folder / name).toFile()).apply {
        environment() += mapOf(
            "SPARK_HOME" to "$home",
            "SPARK_LOCAL_IP" to HOST,
            "SPARK_DAEMON_MEMORY" to "300m",
            "JAVA_HOME" to System.getProperty("java.home"),
        )
    }

    /** Waits until [find] returns something for the output of [name], and returns that. */
    private fun awaitOutput(name: String, find: (String) -> String?): String {
        val end = System.nanoTime() + TimeUnit.MINUTES.toNanos(5)
        while (System.nanoTime() < end) {
            val text = (folder / name).takeIf(Files::exists)?.readText().orEmpty()
            find(text)?.let { return it }
            Thread.sleep(POLL)
        }
        close()
        error("$name does not run:\n${log(name)}")
    }

    override fun close() = (workers.orEmpty() + master).forEach { process ->
        process.descendants().forEach(ProcessHandle::destroyForcibly)
        process.destroyForcibly()
        process.waitFor()
    }

    // Also called before the workers exist.
    private fun List<Process>?.orEmpty(): List<Process> = this ?: emptyList()

    private companion object {
        const val HOST = "127.0.0.1"
        const val POLL = 50L
        val ADDRESS = Regex("spark://127\\.0\\.0\\.1:\\d+")
    }
}
