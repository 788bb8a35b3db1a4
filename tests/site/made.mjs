// node made.mjs SOURCE MVGL BUILD: the site with its demos alive, once for all tests that open it.
import path from 'node:path';
import { liveSite, made, skipUnlessBuilt } from './support.mjs';

const [source, program, build] = process.argv.slice(2);
skipUnlessBuilt(build);
made(source, program, liveSite(build), path.join(build, 'web'));
