package badlog.page

/** Waits until the browser has on its disk what the page has learned of logs so far: it keeps things in the order in which it gets them. */
internal fun OpenPage.awaitKept() {
    driver.executeAsyncScript(
        """
        const done = arguments[0]
        indexedDB.open('badlog', 1).onsuccess = opened => {
            const database = opened.target.result, reading = database.transaction('logs')
            reading.objectStore('logs').count()
            reading.oncomplete = () => {
                database.close()
                done()
            }
        }
        """.trimIndent(),
    )
}
