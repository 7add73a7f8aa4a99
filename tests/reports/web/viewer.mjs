// A viewer for the length of a test.
import { spawn } from 'node:child_process';
import { cylon } from './browser.mjs';

/** Starts `cylon view` in a folder; {url, stop()}, url with the secret; stop gives the exit code.  It ends with the test `t`. */
export async function view(t, cwd, args) {
  const server = spawn(cylon, ['view', ...args, '--no-open', ...(args.includes('--port') ? [] : ['--port', '0'])], { cwd });
  const ended = new Promise((resolve) => server.once('exit', resolve));
  const stop = async () => (server.kill('SIGINT'), await ended);
  t.after(stop);
  const url = await new Promise((resolve, reject) => {
    let text = '';
    for (const stream of [server.stdout, server.stderr])
      stream.on('data', (data) => {
        text += data;
        const found = /http:\/\/127\.0\.0\.1:\d+\/#token=[0-9a-f]{32}/.exec(text);
        if (found) resolve(found[0]);
      });
    server.once('exit', () => reject(new Error(`the server ended: ${text}`)));
  });
  return { url, stop };
}
