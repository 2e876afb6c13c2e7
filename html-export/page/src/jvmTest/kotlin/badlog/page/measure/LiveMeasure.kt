package badlog.page.measure

import badlog.page.RunningLogSpec
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.atomic.AtomicBoolean
import kotlin.concurrent.thread

/** Measures how soon a page shows a robot's new rows, and the Wi-Fi bandwidth for that. Printed by `./gradlew :page:measureLive`. */
internal class LiveMeasure : RunningLogSpec({
    browserTest("50 topics at 50 Hz, from the disk to the screen") {
        onFollowedLog("speed") { robot ->
            script("performance.setResourceTimingBufferSize(10000); performance.clearResourceTimings()")
            val began = System.nanoTime()
            val isOver = AtomicBoolean()
            // The time at which each row was on the disk.
            val written = ConcurrentHashMap<Int, Long>()
            val writing = thread {
                while (!isOver.get()) {
                    robot.write(1)
                    written[robot.rows - 1] = System.nanoTime()
                    Thread.sleep(20)
                }
            }
            // The time of each row from the disk to the screen.
            val late = ArrayList<Double>()
            var shown = robot.rows - 1
            while (System.nanoTime() - began < 15_000_000_000) {
                val last = script("const m = document.querySelector('.range-readout')?.textContent.match(/– (-?[\\d.]+)/); return m ? Number(m[1]) : null")
                    ?.let { Math.round((it as Number).toDouble() * 50).toInt() } ?: continue
                val now = System.nanoTime()
                while (shown < last) late += (now - written.getValue(++shown)) / 1e9
            }
            isOver.set(true)
            writing.join()
            val seconds = (System.nanoTime() - began) / 1e9
            // Includes all headers.
            val bits = number("return performance.getEntriesByType('resource').reduce((sum, e) => sum + e.transferSize, 0)") * 8 / seconds / 1e6
            late.sort()
            println("Live: ${late.size} rows, median %.2f s, 90th percentile %.2f s, worst %.2f s; %.2f Mbit/s".format(late[late.size / 2], late[late.size * 9 / 10], late.last(), bits))
        }
    }
})
